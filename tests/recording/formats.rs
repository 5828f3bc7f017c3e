//! What apps export is read to the numbers that were recorded.
//!
//! The second route: numbers from the maker of the recording, not from the text.

use core::f64::consts::PI;
use kit::recording::Recording;
use kit::recording::made::{Format, Made, Samples};
use support::Errors;

fn made() -> Made {
    Made { accelerometer: Some([0.03, -0.02, 0.01]), ..Made::default() }
}

/// The recording, and the largest differences of times, rates and accelerations.
fn read(name: &str, bytes: &[u8], truth: &Samples) -> (Recording, [f64; 2]) {
    let recording = Recording::read(name, bytes).expect("a recording");
    let shift = truth.times[0] - recording.times()[0];
    assert_eq!(recording.times().len(), truth.times.len(), "{:?}", recording.notes());
    let mut largest = [0.0_f64; 2];
    for (n, t) in truth.times.iter().enumerate() {
        largest[0] = largest[0].max((recording.times()[n] + shift - t).abs());
        for k in 0..3 {
            largest[1] = largest[1].max((recording.rates()[n][k] - truth.rates[n][k]).abs());
        }
    }
    (recording, largest)
}

#[test]
fn every_format_is_read_to_the_recorded_numbers() {
    let truth = made().samples().expect("samples");
    let mut tried = 0;
    for format in Format::ALL {
        // Half a unit of the last digit that is written: of the times (s), of the rates (rad/s).
        let [time, rate] = match format {
            Format::Phyphox | Format::PhyphoxSemicolon | Format::PhyphoxTab => [1e-9, 1e-8],
            Format::SensorLogger => [1e-9, 1e-15],
            Format::AndroSensor => [1e-6, 1e-6],
            Format::Degrees => [1e-7, 1e-5 * PI / 180.0],
            Format::PhysicsToolbox | Format::MatlabMobile | Format::Bare => [1e-6, 1e-6],
        };
        let text = truth.text(format);
        let marked = format!("\u{FEFF}{text}");
        let windows = text.replace('\n', "\r\n");
        let wide = |order: fn(u16) -> [u8; 2]| marked.encode_utf16().flat_map(order).collect();
        let latin: Vec<u8> =
            text.chars().map(|c| u8::try_from(u32::from(c)).expect("Latin-1")).collect();
        let ways: [Vec<u8>; 7] = [
            text.trim_end().into(),
            text.clone().into(),
            marked.clone().into(),
            windows.into(),
            wide(u16::to_le_bytes),
            wide(u16::to_be_bytes),
            latin,
        ];
        for bytes in ways {
            let (_, [times, rates]) = read("recording.csv", &bytes, &truth);
            // A difference of two roundings, and that of the arithmetic.
            assert!(
                times <= time + 1e-12 && rates <= 0.5 * rate + 1e-15,
                "{format:?}: {times} {rates}"
            );
            tried += 1;
        }
    }
    assert_eq!(tried, 63);
}

#[test]
fn what_was_recognised_is_told() {
    let truth = made().samples().expect("samples");
    let notes: Vec<String> = Format::ALL
        .map(|format| {
            let text = truth.text(format);
            Recording::read("a.csv", text.as_bytes()).expect("a recording").notes().join(" ")
        })
        .into();
    insta::assert_snapshot!(notes.join("\n"), @r#"
    Read as a table of phyphox. 560 samples in 2.795 s, 200.0 a second. Accelerations were read as well.
    Read as a table of phyphox. 560 samples in 2.795 s, 200.0 a second. Accelerations were read as well.
    Read as a table of phyphox. 560 samples in 2.795 s, 200.0 a second. Accelerations were read as well.
    Read as a table of Physics Toolbox. The times have no unit: by their steps of 0.005016 they are in s. 560 samples in 2.795 s, 200.0 a second. Accelerations were read as well.
    Read as a table of Sensor Logger. 560 samples in 2.795 s, 200.0 a second. The rates have no unit: they were taken as rad/s.
    Read as a table of MATLAB Mobile. Times count from the first sample. 560 samples in 2.795 s, 200.0 a second. The rates have no unit: they were taken as rad/s.
    Read as a table of AndroSensor. 560 samples in 2.795 s, 200.0 a second. Accelerations were read as well.
    Read as a table. 560 samples in 2.795 s, 200.0 a second. The rates were converted from deg/s.
    Read as a table without a header. The times have no unit: by their steps of 0.005016 they are in s. 560 samples in 2.795 s, 200.0 a second. The rates have no unit: they were taken as rad/s.
    "#);
}

#[test]
fn accelerations_are_read_in_g_and_in_metres() {
    let truth = made().samples().expect("samples");
    let felt = truth.accelerations.as_deref().expect("an accelerometer");
    let mut errors = Errors::in_units_of(1e-4, "accelerations (1e-4 m/s^2)");
    for format in [Format::Phyphox, Format::PhysicsToolbox, Format::AndroSensor] {
        let recording = Recording::read("a.csv", truth.text(format).as_bytes()).expect("read");
        let read = recording.accelerations().expect("accelerations");
        for (read, felt) in read.iter().zip(felt) {
            for k in 0..3 {
                errors.add(read[k], felt[k], 1.0);
            }
        }
    }
    support::assert_largest!(errors, 5040, @"0.490");
}

/// A table with one row for each sample.
fn table(header: &str, row: impl Fn(f64, [f64; 3]) -> String) -> String {
    let rows = (0..200).map(|k| 0.005 * f64::from(k)).map(|t| row(t, rates(t)));
    format!("{header}\n{}", rows.collect::<Vec<_>>().join("\n"))
}

/// Any rates.
fn rates(t: f64) -> [f64; 3] {
    [1.0 + t, t * t - 2.0, 3.0 * t]
}

#[test]
fn other_tables_are_read_too() {
    let degrees = |w: f64| w * 180.0 / PI;
    let tables = [
        // Physics Toolbox with Greek letters, by tabs.
        table("time\tωₓ (rad/s)\tωᵧ (rad/s)\tωz (rad/s)\tω (rad/s)", |t, [x, y, z]| {
            format!("{t}\t{x}\t{y}\t{z}\t{}", x * x + y * y)
        }),
        // By spaces.
        table("time  ωₓ (rad/s)  ωᵧ (rad/s)  ωz (rad/s)", |t, [x, y, z]| {
            format!("  {t}   {x}  {y}  {z}")
        }),
        table("", |t, [x, y, z]| format!("{t} {x} {y} {z}").replace('.', ",")),
        // Several sensors of Physics Toolbox take lines in turn.
        table("time,gFx,gFy,gFz,TgF,wx,wy,wz", |t, [x, y, z]| {
            format!("{t},0.{},0.2,{t},1,,,\n{:.4},,,,,{x},{y},{z}", 1, t)
        }),
        // phyphox fills a shorter column up, and each sensor has its own clock.
        table(
            "\"Acceleration time (s)\",\"Acceleration x (m/s^2)\",\"Acceleration y (m/s^2)\",\"Acceleration z (m/s^2)\",\"Gyroscope time (s)\",\"Gyroscope x (rad/s)\",\"Gyroscope y (rad/s)\",\"Gyroscope z (rad/s)\"",
            |t, [x, y, z]| format!("{},{t},2,3,{t},{x},{y},{z}", 2.0 * t),
        ) + "\n2.5,1,2,3,NaN,NaN,NaN,NaN",
        // A language that is not English.
        table(
            "\"Zeit (s)\";\"Gyroskop x (rad/s)\";\"Gyroskop y (rad/s)\";\"Gyroskop z (rad/s)\"",
            |t, [x, y, z]| format!("{t};{x};{y};{z}").replace('.', ","),
        ),
        // Quoted numbers with a decimal comma.
        table("time,gyro_x,gyro_y,gyro_z", |t, [x, y, z]| {
            format!("\"{t}\",\"{x}\",\"{y}\",\"{z}\"").replace('.', ",").replace("\",,\"", "\",\"")
        }),
        table("sep=;\nt;GyroX (°/s);GyroY (°/s);GyroZ (°/s)", |t, w| {
            let [x, y, z] = w.map(degrees);
            format!("{t};{x};{y};{z}")
        }),
        table("elapsed (s),x-axis (deg/s),y-axis (deg/s),z-axis (deg/s)", |t, w| {
            let [x, y, z] = w.map(degrees);
            format!("{t},{x},{y},{z}")
        }),
        table("timestamp_us,gyro_x_dps,gyro_y_dps,gyro_z_dps", |t, w| {
            let [x, y, z] = w.map(degrees);
            format!("{},{x},{y},{z}", (1e6 * t).round())
        }),
        table("time_ns,rotationRateZ,rotationRateY,rotationRateX", |t, [x, y, z]| {
            format!("{},{z},{y},{x}", (1e9 * t).round())
        }),
        table("time,roll rate (rad/s),pitch rate (rad/s),yaw rate (rad/s)", |t, [x, y, z]| {
            format!("2024-03-01T23:59:{:06.3}Z,{x},{y},{z}", 59.5 + t)
                .replace(":60.", ":00.")
                .replace("23:59:00", "00:00:00")
        }),
        table("Timestamp,X,Y,Z", |t, [x, y, z]| format!("{t} sec,{x},{y},{z}")),
        // Names in a comment.
        table("# time (s),x (deg/s),y (deg/s),z (deg/s)", |t, w| {
            let [x, y, z] = w.map(degrees);
            format!("{t},{x},{y},{z}")
        }),
        table("# made by hand\n#  t   wz   wy   wx", |t, [x, y, z]| format!("{t}  {z} {y} {x}")),
        // A line of units.
        table("t,x,y,z\n(s),(deg/s),(deg/s),(deg/s)", |t, w| {
            let [x, y, z] = w.map(degrees);
            format!("{t},{x},{y},{z}")
        }),
        table("us;x;y;z", |t, [x, y, z]| format!("{};{x};{y};{z}", (1e6 * t).round())),
        table("t (s),gyro x (rpm),gyro y (rpm),gyro z (rpm)", |t, w| {
            let [x, y, z] = w.map(|w| 30.0 * w / PI);
            format!("{t},{x},{y},{z}")
        }),
        table("t (s),gx (rev/s),gy (rev/s),gz (rev/s)", |t, w| {
            let [x, y, z] = w.map(|w| 0.5 * w / PI);
            format!("{t},{x},{y},{z}")
        }),
        table("t (s),gx (mrad/s),gy (mrad/s),gz (mrad/s)", |t, w| {
            let [x, y, z] = w.map(|w| 1e3 * w);
            format!("{t},{x},{y},{z}")
        }),
        // Other sensors, and a minus of printers.
        table("time,ax,ay,az,gx,gy,gz,mx,my,mz", |t, [x, y, z]| {
            format!("{t},1,{t},3,{x},{y},{z},7,8,9").replace('-', "\u{2212}")
        }),
        table(
            "t,GyroscopeUncalibrated_x,GyroscopeUncalibrated_y,GyroscopeUncalibrated_z,Gyroscope_x,Gyroscope_y,Gyroscope_z",
            |t, [x, y, z]| format!("{t},1,{t},3,{x},{y},{z}"),
        ),
        table("% t (s) wx (rad/s) wy (rad/s) wz (rad/s)", |t, [x, y, z]| {
            format!("{t} {x} {y} {z}")
        }),
    ];
    let mut tried = 0;
    for text in &tables {
        let recording = Recording::read("gyroscope.csv", text.as_bytes());
        let recording = recording.unwrap_or_else(|error| panic!("{error} in {text:.120}"));
        assert_eq!(recording.times().len(), 200, "{text:.100}");
        for (k, (t, w)) in recording.times().iter().zip(recording.rates()).enumerate() {
            let expected = 0.005 * k as f64;
            assert!((t - expected).abs() < 1e-9, "{t} {expected} in {text:.100}");
            let expected = rates(expected);
            for i in 0..3 {
                assert!((w[i] - expected[i]).abs() < 1e-12, "{w:?} {expected:?} in {text:.100}");
            }
        }
        tried += 1;
    }
    assert_eq!(tried, 23);
}

#[test]
fn accelerations_with_a_clock_of_their_own_are_interpolated() {
    let header = "t1 (s),acc x (m/s^2),acc y (m/s^2),acc z (m/s^2),t2 (s),wx,wy,wz";
    // They are 2 t, by their clock.
    let text = table(header, |t, [x, y, z]| {
        format!("{},{},{},{},{t},{x},{y},{z}", 1.3 * t, 2.6 * t, 5.2 * t, 7.8 * t)
    });
    let recording = Recording::read("", text.as_bytes()).expect("read");
    let felt = recording.accelerations().expect("accelerations");
    assert_eq!(felt.len(), 200);
    for (t, a) in recording.times().iter().zip(felt) {
        assert!((a[0] - 2.0 * t).abs() < 1e-12 && (a[2] - 6.0 * t).abs() < 1e-12);
    }
    assert!(recording.notes().iter().any(|note| note.contains("interpolated")));
}

#[test]
fn repeated_times_are_averaged_and_gaps_told() {
    // Every tenth line is there twice.
    let mut text = table("time (s),wx (rad/s),wy (rad/s),wz (rad/s)", |t, [x, y, z]| {
        let again = format!("\n{t},{},{y},{}", x + 0.2, z - 0.4);
        let again = if (200.0 * t).round() % 10.0 == 0.0 { again } else { String::new() };
        format!("{t},{x},{y},{z}{again}")
    });
    text.push_str("\n1.5,1,2,3");
    let recording = Recording::read("", text.as_bytes()).expect("read");
    assert_eq!(recording.times().len(), 201);
    for (t, w) in recording.times().iter().zip(recording.rates()).step_by(10).take(20) {
        let [x, y, z] = rates(*t);
        assert!((w[0] - x - 0.1).abs() < 1e-12 && w[1] == y && (w[2] - z + 0.2).abs() < 1e-12);
    }
    let notes = recording.notes().join("\n");
    assert!(notes.contains("line before: 20; they were averaged"), "{notes}");
    assert!(notes.contains("1; the first is from 0.9950 s to 1.5000 s"), "{notes}");
    // Two are averaged, and the header is a line.
    assert_eq!(recording.place(10), "line 13, t = 0.0500000 s");
    assert_eq!(recording.place(999), "sample 999, of 201");
}

#[test]
fn the_app_and_the_calibrated_rates_are_told() {
    let notes = |bytes: &[u8]| Recording::read("", bytes).expect("read").notes().join(" ");
    let german =
        table("Zeit (s);wx (°/s);wy (°/s);wz (°/s)", |t, [x, y, z]| format!("{t};{x};{y};{z}"));
    let latin = german.chars().map(|c| u8::try_from(u32::from(c)).expect("Latin-1"));
    let said = notes(&latin.collect::<Vec<_>>());
    assert!(said.starts_with("Read as a table. "), "{said}");
    let both = "t,gyroUncal_x,gyroUncal_y,gyroUncal_z,gyro_x,gyro_y,gyro_z";
    let both = table(both, |t, [x, y, z]| format!("{t},1,2,3,{x},{y},{z}"));
    let alone = both.replace(",gyro_", ",other_");
    let calibrated = "the calibrated ones were taken";
    assert!(notes(both.as_bytes()).contains(calibrated));
    assert!(Recording::read("", alone.as_bytes()).is_err(), "1, 2, 3 are constant");
}

#[test]
fn stamps_that_repeat_are_spread_over_regular_samples() {
    // Stamps in steps of 20 ms, or one in ten that is late.
    let stamps: [fn(f64) -> f64; 2] = [
        |t| 0.02 * (50.0 * t + 1e-9).floor(),
        |t| if (200.0 * t).round() % 10.0 == 5.0 { t - 0.005 } else { t },
    ];
    for (stamp, repeated) in stamps.into_iter().zip([150, 20]) {
        let text = table("time (s),wx (rad/s),wy (rad/s),wz (rad/s)", |t, [x, y, z]| {
            format!("{:.6},{x},{y},{z}", stamp(t))
        });
        let recording = Recording::read("", text.as_bytes()).expect("read");
        assert_eq!(recording.times().len(), 200);
        for (k, t) in recording.times().iter().enumerate() {
            assert!((t - 0.005 * k as f64).abs() < 1e-9, "{k} {t}");
        }
        let notes = recording.notes().join("\n");
        assert!(
            notes.contains(&format!("line before: {repeated}; samples come regularly")),
            "{notes}"
        );
    }
}

#[test]
fn a_sensor_at_its_limit_is_told() {
    let header = "time (s),wx (deg/s),wy (deg/s),wz (deg/s)";
    let text = |limit: f64| {
        table(header, |t, [x, y, z]| format!("{t},{x},{y},{}", (1000.0 * z).min(limit)))
    };
    let notes =
        |limit| Recording::read("", text(limit).as_bytes()).expect("read").notes().join(" ");
    assert!(notes(2000.0).contains("rate about z stays at 34.91 rad/s"), "{}", notes(2000.0));
    assert!(!notes(4000.0).contains("stays"));
    // No sensor ends there.
    assert!(!notes(1700.0).contains("stays"));
}

#[test]
fn pieces_by_hand() {
    let text = table("time (s),wx,wy,wz", |t, [x, y, z]| format!("{t},{x},{y},{z}"));
    let recording = Recording::read("", text.as_bytes()).expect("read");
    let between = |from, to| recording.between(from, to).map_err(|error| error.to_string());
    assert_eq!(between(None, None), Ok(0..200));
    assert_eq!(between(Some(0.1), Some(0.2)), Ok(20..41));
    assert_eq!(between(Some(0.101), None), Ok(21..200));
    assert_eq!(between(Some(-1.0), Some(9.0)), Ok(0..200));
    insta::assert_snapshot!(between(Some(0.1), Some(0.12)).unwrap_err(), @"from 0.1 s to 0.12 s there are 5 samples; a fit needs 13 or more");
    insta::assert_snapshot!(between(Some(0.3), Some(0.2)).unwrap_err(), @"from 0.3 s to 0.2 s: the end must be later");
    insta::assert_snapshot!(between(Some(-1.0), Some(-0.5)).unwrap_err(), @"from -1 s to -0.5 s: the recording is from 0 s to 0.995 s");
    insta::assert_snapshot!(between(Some(1.0), Some(2.0)).unwrap_err(), @"from 1 s to 2 s: the recording is from 0 s to 0.995 s");
    insta::assert_snapshot!(between(None, Some(f64::NAN)).unwrap_err(), @"from 0 s to NaN s: the end must be later");
}
