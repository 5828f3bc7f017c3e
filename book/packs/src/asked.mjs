// What a page is asked: to see what it needs, and that it tells what the terminal does.

// The values of a parameter other than its default: the words, or the ends of its usual range.
function values({ words, from, to, default: own }) {
  return words.length > 0 ? words.filter((word) => word !== own) : [from, to].filter((value) => value !== null);
}

// The lines of `open`: as declared, then one parameter after another.
export function settings({ flags }) {
  const lines = ['', 'no such parameter=1'];
  for (const flag of flags) {
    for (const value of values(flag)) lines.push(`${flag.name}=${value}`);
    if (flag.kind === 'effect') lines.push(`${flag.name}=`, `${flag.name}=${flag.usual}`);
    else lines.push(`${flag.name}=x`);
  }
  return lines;
}

// The command lines of `run`: what every example knows, then one parameter after another, then
// what it refuses.
export function commands({ flags }) {
  const lines = [['--help'], ['--json'], ['--csv', 'motion.csv'], ['--svg', 'figures'], ['--no-such-flag', '1'], ['--check', 'x=1']];
  for (const flag of flags) {
    const option = `--${flag.name}`;
    if (flag.kind === 'effect') lines.push(['--with', flag.name], ['--without', flag.name], ['--with', `${flag.name}=-1e9`]);
    else {
      for (const value of values(flag)) lines.push([option, `${value}`]);
      lines.push([option, 'x'], [option, '-1e9']);
    }
  }
  return [[], ...lines];
}
