//! Global error control: time without bound, reasons that are not the reason.
