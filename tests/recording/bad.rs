//! Files that are no recordings: each is refused with line, column and what is expected, and none panics.

use kit::recording::Recording;
use kit::recording::made::{Format, Made};
use support::Random;

/// A good table of twenty lines, with one line in the place of line `n` (from 1).
fn but(n: usize, line: &str) -> String {
    let header =
        "\"Time (s)\",\"Gyroscope x (rad/s)\",\"Gyroscope y (rad/s)\",\"Gyroscope z (rad/s)\"";
    let rows = (0..20)
        .map(|k| 0.01 * f64::from(k))
        .map(|t| format!("{t:.2},{},{},{}", t - 1.0, 2.0 * t, t * t));
    let mut lines: Vec<String> = core::iter::once(header.into()).chain(rows).collect();
    lines[n - 1] = line.into();
    lines.join("\n")
}

fn error(name: &str, bytes: &[u8]) -> String {
    match Recording::read(name, bytes) {
        Ok(recording) => format!("read: {:?}", recording.notes()),
        Err(error) => error.to_string(),
    }
}

#[test]
fn bad_files_are_refused_in_words() {
    let rows = |row: &str| vec![row; 20].join("\n");
    let few: String = but(1, "time,wx,wy,wz").lines().take(9).collect::<Vec<_>>().join("\n");
    let constant = but(1, "t,wx,wy,wz").replace(",0\n", ",0.5\n");
    let constant = constant.lines().map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        if cells[0] == "t" {
            line.to_string()
        } else {
            format!("{},{},0.25,{}", cells[0], cells[1], cells[3])
        }
    });
    let constant = constant.collect::<Vec<_>>().join("\n");
    let ms = (0..20).map(|k| format!("{},{k},{},-{k}\n", 10 * k, k % 3)).collect::<String>();
    let ms = format!("Time (s),wx,wy,wz\n{ms}");
    let cases: Vec<(&str, &str, Vec<u8>)> = vec![
        ("empty", "a.csv", Vec::new()),
        ("spaces alone", "a.csv", b" \r\n\n  ".into()),
        ("a mark alone", "a.csv", b"\xEF\xBB\xBF".into()),
        ("a PNG", "a.png", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".into()),
        ("a JPEG", "a.csv", b"\xFF\xD8\xFF\xE0\0\x10JFIF".into()),
        ("a zip", "a.zip", b"PK\x03\x04\x14\0".into()),
        ("an xls", "a.xls", b"\xD0\xCF\x11\xE0\xA1\xB1".into()),
        ("a gzip", "a.csv", b"\x1F\x8B\x08\0".into()),
        ("JSON", "a.json", b"[{\"sensor\":\"Gyroscope\",\"time\":\"1\"}]".into()),
        ("a page", "a.csv", b"<!DOCTYPE html><p>1,2,3,4".into()),
        ("bytes", "a.csv", vec![7, 0, 9, 200, 0, 1, 2]),
        ("prose", "a.txt", b"Dear teacher,\nmy phone fell.\n".into()),
        ("no time", "a.csv", but(1, "n,wx,wy,wz").into()),
        ("no z", "a.csv", but(1, "time,wx,wy,bz").into()),
        ("other sensor", "a.csv", but(1, "Time (s),Bx (uT),By (uT),Bz (uT)").into()),
        ("accelerometer alone", "a.csv", but(1, "\"Time (s)\",\"Acceleration x (m/s^2)\",\"Acceleration y (m/s^2)\",\"Acceleration z (m/s^2)\"").into()),
        ("accelerometer's file", "Accelerometer.csv", but(1, "Timestamp,X,Y,Z").into()),
        ("its other file", "Downloads/gyro/TotalAcceleration.csv", but(1, "seconds_elapsed,z,y,x").into()),
        ("unit", "a.csv", but(1, "Time (s),Gyro x (lx),Gyro y (lx),Gyro z (lx)").into()),
        ("three columns", "a.csv", rows("1 2 3").into()),
        ("five columns", "a.csv", rows("1;2;3;4;5").into()),
        ("six columns", "a.csv", rows("1,2,3,4,5,6").into()),
        ("text", "a.csv", but(7, "0.05,-0.95,oops,0.0025").into()),
        ("text after a comment", "a.csv", format!("# a\n\n# b\n{}", but(7, "0.05,-0.95,oops,0.0025")).into()),
        ("text and Windows", "a.csv", but(7, "0.05,-0.95,oops,0.0025").replace('\n', "\r\n").into()),
        ("another header", "a.csv", but(9, "Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)").into()),
        ("no number", "a.csv", but(8, "0.06,NaN,1,2").into()),
        ("infinite", "a.csv", but(8, "0.06,1,2,-inf").into()),
        ("too large a number", "a.csv", but(8, "0.06,1,2,1e999").into()),
        ("no number for the time", "a.csv", but(8, "NaN,1,2,3").into()),
        ("empty cell", "a.csv", but(8, "0.06,1,,3").into()),
        ("cut off", "a.csv", but(21, "0.19,-0.8").into()),
        ("no time in a line", "a.csv", but(8, ",1,2,3").into()),
        ("backwards", "a.csv", but(12, "0.02,1,2,3").into()),
        ("a clock backwards", "a.csv", (0..20).map(|k| format!("10:20:{:02},{k},1,{k}\n", 40 - k)).collect::<String>().into()),
        ("a clock that is none", "a.csv", but(8, "10:xx:12,1,2,3").into()),
        ("constant", "a.csv", constant.into()),
        ("few", "a.csv", few.into()),
        ("header alone", "a.csv", but(1, "time,wx,wy,wz").lines().next().map_or(Vec::new(), Into::into)),
        ("impossible", "a.csv", but(8, "0.06,1,20000,3").into()),
        ("degrees", "a.csv", but(8, "0.06,1,-743.5,3").replace(" (rad/s)", "").into()),
        ("degrees as rad", "a.csv", but(8, "0.06,1,-743.5,3").into()),
        ("ms as s", "a.csv", ms.into()),
        ("s as ms", "a.csv", but(1, "Time (ms),wx,wy,wz").into()),
        ("a note", "a.csv", but(9, "Anna caught it here, ask her").into()),
        ("commas for all", "a.csv", but(1, "t,wx,wy,wz").replace("1,", "1,0,").replace(",0", ",0,0").into()),
        ("times without digits", "a.csv", rows("1.71499E+12,1,2,3").into()),
    ];
    let lines: Vec<String> =
        cases.iter().map(|(what, name, bytes)| format!("{what}: {}", error(name, bytes))).collect();
    assert_eq!(lines.len(), 47);
    assert!(lines.iter().all(|line| !line.contains(": read: ")), "{}", lines.join("\n"));
    insta::assert_snapshot!(lines.join("\n"), @r#"
    empty: the file is empty; expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    spaces alone: the file is empty; expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    a mark alone: the file is empty; expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    a PNG: the file is a picture (PNG), not a table of numbers
    a JPEG: the file is a picture (JPEG), not a table of numbers
    a zip: the file is an archive (zip) or a workbook (xlsx): unpack it and choose the table of the gyroscope, or export as CSV
    an xls: the file is a workbook (xls): export as CSV
    a gzip: the file is an archive (gzip): unpack it
    JSON: the file is JSON: export as CSV
    a page: the file is XML or HTML: export as CSV
    bytes: the file is not text: export the recording as CSV
    prose: the file has no table of numbers; expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    no time: line 1: the header has no column for the time: n | wx | wy | wz; expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    no z: line 1: the header has no column for the rate about z: time | wx | wy | bz; expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    other sensor: line 1: the header has no column for the rate about x, y, z: Time (s) | Bx (uT) | By (uT) | Bz (uT); expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    accelerometer alone: line 1: the header has no column for the rate about x, y, z: Time (s) | Acceleration x (m/s^2) | Acceleration y (m/s^2) | Acceleration z (m/s^2); expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    accelerometer's file: line 1: by the file's name its columns x, y, z are not the rates of a gyroscope: choose the file of the gyroscope ("Gyroscope.csv")
    its other file: line 1: by the file's name its columns x, y, z are not the rates of a gyroscope: choose the file of the gyroscope ("Gyroscope.csv")
    unit: line 1: the unit (lx) of "Gyro x (lx)" is not known: expected (rad/s), (mrad/s), (deg/s), (rev/s) or (rpm)
    three columns: line 1: there are 3 columns and no header; expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    five columns: line 1: there are 5 columns and no header; expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    six columns: line 1: there are 6 columns and no header; expected a time and three rates, such as "Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)"
    text: line 7, column 3 (Gyroscope y (rad/s)): "oops" is not a number
    text after a comment: line 10, column 3 (Gyroscope y (rad/s)): "oops" is not a number
    text and Windows: line 7, column 3 (Gyroscope y (rad/s)): "oops" is not a number
    another header: line 9: "Time (s),Gyroscope x (rad/s),Gyroscope y" are no numbers
    no number: line 8, column 2 (Gyroscope x (rad/s)): "NaN" is not a finite number
    infinite: line 8, column 4 (Gyroscope z (rad/s)): "-inf" is not a finite number
    too large a number: line 8, column 4 (Gyroscope z (rad/s)): "1e999" is not a finite number
    no number for the time: line 8, column 1 (Time (s)): "NaN" is not a finite number
    empty cell: line 8, column 3 (Gyroscope y (rad/s)): the cell is empty: expected a number
    cut off: line 21, column 3 (Gyroscope y (rad/s)): the cell is empty: expected a number
    no time in a line: line 8, column 1 (Time (s)): the cell is empty: expected a number
    backwards: line 12, column 1 (Time (s)): the time 0.02 is before that of a line above: times must ascend
    a clock backwards: line 2, column 1: the time 10:20:39 is before that of a line above: times must ascend
    a clock that is none: line 8, column 1 (Time (s)): "10:xx:12" is neither a number nor a time
    constant: column 3 (wy): it shows 0.25 in every line; expected a rate that changes
    few: lines with rates: 8; expected 13 or more
    header alone: lines with rates: 0; expected 13 or more
    impossible: line 8, column 3 (Gyroscope y (rad/s)): 20000 would be 20000 rad/s; no phone shows more than 100: these are probably degrees per second, which the header must say, as in "Gyroscope x (deg/s)"
    degrees: line 8, column 3 (Gyroscope y): -743.5 would be -743.5 rad/s; no phone shows more than 100: these are probably degrees per second, which the header must say, as in "Gyroscope x (deg/s)"
    degrees as rad: line 8, column 3 (Gyroscope y (rad/s)): -743.5 would be -743.5 rad/s; no phone shows more than 100: these are probably degrees per second, which the header must say, as in "Gyroscope x (deg/s)"
    ms as s: column 1 (Time (s)): 0.10 samples a second: are the times in ms?
    s as ms: column 1 (Time (ms)): 100000 samples a second: are the times in s?
    a note: line 9: "Anna caught it here, ask her" are no numbers
    commas for all: line 2, column 5: there are 8 cells under 4 names: if commas are both decimal and between columns, export with decimal points or with semicolons
    times without digits: column 1: different times in 20 lines: 1; expected 13 or more: are they written with all digits?
    "#);
}

#[test]
fn the_good_table_is_read() {
    // The twin of all that is refused above.
    let text = but(8, "0.06,-0.94,0.12,0.0036");
    let recording = Recording::read("a.csv", text.as_bytes()).expect("a recording");
    assert_eq!(recording.times().len(), 20);
}

#[test]
fn mangled_files_never_panic() {
    let made = Made { accelerometer: Some([0.0; 3]), frequency: 50.0, ..Made::default() };
    let samples = made.samples().expect("samples");
    let mut random = Random(3);
    let (mut tried, mut read) = (0, 0);
    for format in Format::ALL {
        let good = samples.text(format).into_bytes();
        for case in 0..60 {
            let mut bytes = good.clone();
            let mut place = |length: usize| (random.unit() * length as f64) as usize;
            match case % 6 {
                0 => bytes.truncate(place(good.len())),
                1 => drop(bytes.drain(..place(good.len()))),
                2 => (0..3).for_each(|_| bytes[place(good.len())] = place(256) as u8),
                3 => (0..3).for_each(|_| {
                    bytes.insert(place(good.len()), b"\",;\t\n\r#-eE.:0 "[place(14)])
                }),
                4 => {
                    let [from, to] = [place(good.len()), place(good.len())];
                    drop(bytes.drain(from.min(to)..from.max(to)));
                }
                _ => {
                    let header = good.len().min(120);
                    (0..2).for_each(|_| bytes[place(header)] = place(128) as u8);
                }
            }
            if let Ok(recording) = Recording::read("Gyroscope.csv", &bytes) {
                read += 1;
                let (times, rates) = (recording.times(), recording.rates());
                assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
                assert!(times.iter().chain(rates.iter().flatten()).all(|x| x.is_finite()));
                assert_eq!(recording.accelerations().map_or(rates.len(), <[_]>::len), rates.len());
                let _ = recording.flights();
            }
            tried += 1;
        }
    }
    // Many of them are still recordings, and many are not.
    assert_eq!((tried, read), (540, 132));
}
