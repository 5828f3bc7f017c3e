//! The field of a page for a reader's own recording. `theme/recording.js` brings it to life; without it
//! nothing is shown.

use crate::live::Modules;
use crate::notation;
use crate::text::{escape, unit_html};

/// What is asked of a recording itself: the flag, its label, its unit.
const OWN: [(&str, &str, &str); 3] =
    [("throw", "which throw", ""), ("from", "from", "s"), ("to", "to", "s")];

impl Modules {
    /// The field of `stem`, with these flags parted by spaces; nothing if it has no module.
    pub fn recording(&self, stem: &str, flags: &str, prefix: &str) -> String {
        if self.page(stem).is_none() {
            return String::new();
        }
        let size = if flags.contains("width") { ", and your phone’s size" } else { "" };
        let knobs: String = flags.split(' ').map(|name| self.entry(stem, name, prefix)).collect();
        format!(
            "<div class=\"recording\" role=\"group\" aria-label=\"Your own recording\" data-stem=\"{stem}\">\
             <p class=\"choose\"><label for=\"{prefix}file\">A recording from your phone</label>\
             <input type=\"file\" id=\"{prefix}file\" aria-describedby=\"{prefix}told {prefix}stays\">\
             <button type=\"button\" class=\"made\" disabled>Try a made-up recording</button></p>\
             <p class=\"stays\" id=\"{prefix}stays\">You can also drop the file here. This page reads it by itself: \
             nothing leaves your device.</p>\
             <p class=\"refusal\" id=\"{prefix}told\" role=\"alert\"></p>\
             <details class=\"fold\"><summary>Which piece of it{size}</summary>\
             <div class=\"knobs\">{knobs}</div></details>\
             <p class=\"status\" role=\"status\"></p><div class=\"result\"></div></div>"
        )
    }

    /// The entry of a flag: one of the recording itself, or a parameter of the page, which stays empty.
    fn entry(&self, stem: &str, name: &str, prefix: &str) -> String {
        let own = OWN.iter().find(|(own, ..)| *own == name);
        let declared = self.flags(stem).iter().find(|flag| flag["name"] == name);
        let text = |key: &str| declared.and_then(|flag| flag[key].as_str()).unwrap_or_default();
        let (label, unit) = match own {
            Some((_, label, unit)) => (*label, *unit),
            None => (text("meaning"), text("unit")),
        };
        format!(
            "<div class=\"knob\"><label for=\"{prefix}{name}\">{}</label><span class=\"entry\"><input class=\"value\" \
             id=\"{prefix}{name}\" data-flag=\"{name}\" inputmode=\"decimal\" size=\"9\" autocomplete=\"off\" \
             spellcheck=\"false\" placeholder=\"{}\"><span class=\"unit\">{}</span></span></div>",
            notation::words(label),
            escape(if own.is_some() { "found" } else { "" }),
            unit_html(unit.trim_start_matches('-')),
        )
    }
}
