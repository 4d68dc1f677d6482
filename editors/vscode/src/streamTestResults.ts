import * as vscode from 'vscode';
import { Outcome } from './commandLine';

/** A test, as `arcomat test --format json` tells of it. */
interface Result {
  readonly file: string;
  readonly line: number;
  readonly name: string;
  readonly verdict: 'passed' | 'vacuous' | 'failed' | 'unknown';
  readonly reason?: string | null;
  readonly failure?: string | null;
  readonly streams: readonly Cell[];
}

interface Cell {
  readonly slice: number;
  readonly port: string;
  readonly expected: readonly unknown[];
  readonly actual: readonly unknown[];
  readonly differs: boolean;
}

interface Finding {
  readonly code: string;
  readonly message: string;
  readonly file: string;
  readonly start: { readonly line: number };
}

/**
 * Tells the test explorer what became of some tests of one suite.
 *
 * @param isSuite whether a path is that of the suite
 */
export function tell(
  run: vscode.TestRun,
  tests: readonly vscode.TestItem[],
  outcome: Outcome,
  isSuite: (file: string) => boolean,
): void {
  const results = resultsOf(outcome);
  if (!results) {
    const reason = new vscode.TestMessage(refusal(outcome));
    tests.forEach((test) => run.errored(test, reason));
    return;
  }
  for (const test of tests) {
    const result = results.find((each) => each.name === test.label && isSuite(each.file));
    if (result) {
      tellOne(run, test, result);
    } else {
      run.skipped(test);
    }
  }
}

/** Nothing where models have errors: then findings are told instead. */
function resultsOf(outcome: Outcome): readonly Result[] | undefined {
  try {
    return (JSON.parse(outcome.out) as { tests?: Result[] }).tests;
  } catch {
    return undefined;
  }
}

function refusal(outcome: Outcome): string {
  try {
    const findings = (JSON.parse(outcome.out) as { findings?: Finding[] }).findings ?? [];
    return findings.map((each) => `${each.file}:${each.start.line}: ${each.code} ${each.message}`).join('\n') || outcome.err;
  } catch {
    return outcome.err || outcome.out;
  }
}

function tellOne(run: vscode.TestRun, test: vscode.TestItem, result: Result): void {
  if (result.verdict === 'passed') {
    run.passed(test);
  } else if (result.verdict === 'vacuous') {
    run.appendOutput(`${test.label} passed vacuously: the model promises nothing any more\r\n`, undefined, test);
    run.passed(test);
  } else {
    run.failed(test, message(test, result));
  }
}

function message(test: vscode.TestItem, result: Result): vscode.TestMessage {
  const reason = result.reason ?? result.failure;
  const head = result.verdict === 'unknown' ? 'Nobody knows' : 'The model does not do this';
  const text = new vscode.TestMessage(`${head}${reason ? `: ${reason}` : ''}\n\n${table(result)}`);
  text.expectedOutput = streams(result, (cell) => cell.expected);
  text.actualOutput = streams(result, (cell) => cell.actual);
  if (test.uri && test.range) {
    text.location = new vscode.Location(test.uri, test.range);
  }
  return text;
}

function table(result: Result): string {
  const differing = result.streams.filter((cell) => cell.differs);
  return differing
    .map((cell) => `slice ${cell.slice}: ${cell.port} was expected to send ${shown(cell.expected)}, and sends ${shown(cell.actual)}`)
    .join('\n');
}

function streams(result: Result, of: (cell: Cell) => readonly unknown[]): string {
  return result.streams.map((cell) => `slice ${cell.slice}  ${cell.port}  ${shown(of(cell))}`).join('\n');
}

function shown(messages: readonly unknown[]): string {
  return messages.length > 0 ? messages.map(String).join(', ') : '--';
}
