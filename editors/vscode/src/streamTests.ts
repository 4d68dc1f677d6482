import { existsSync } from 'node:fs';
import * as path from 'node:path';
import * as vscode from 'vscode';
import { CommandLine } from './commandLine';
import { homeOf, MADE, modelRoot, saveAll, textOf, withoutComments } from './models';
import { ReportPages } from './reportPages';
import { tell } from './streamTestResults';

const NAME = '[\\p{L}_$][\\p{L}\\p{N}_$]*';

/** Stream tests in the test explorer: a file, and its tests below. */
export function registerStreamTests(tool: CommandLine, pages: ReportPages): vscode.Disposable {
  const controller = vscode.tests.createTestController('arcomat', 'Arcomat stream tests');
  const tests = new StreamTests(controller, tool, pages);
  const watcher = vscode.workspace.createFileSystemWatcher('**/*.mt');
  watcher.onDidCreate((file) => tests.read(file));
  watcher.onDidChange((file) => tests.read(file));
  watcher.onDidDelete((file) => controller.items.delete(file.toString()));
  controller.resolveHandler = () => tests.readAll();
  controller.refreshHandler = () => tests.readAll();
  controller.createRunProfile('Run', vscode.TestRunProfileKind.Run, (asked, stop) => tests.run(asked, stop, false), true);
  controller.createRunProfile('Run and Step Through', vscode.TestRunProfileKind.Debug, (asked, stop) => tests.run(asked, stop, true));
  void tests.readAll();
  return vscode.Disposable.from(controller, watcher);
}

class StreamTests {
  constructor(
    private readonly controller: vscode.TestController,
    private readonly tool: CommandLine,
    private readonly pages: ReportPages,
  ) {}

  async readAll(): Promise<void> {
    const files = await vscode.workspace.findFiles('**/*.mt', MADE);
    await Promise.all(files.map((file) => this.read(file)));
  }

  async read(file: vscode.Uri): Promise<void> {
    const text = withoutComments(Buffer.from(await vscode.workspace.fs.readFile(file)).toString('utf8'));
    const suite = new RegExp(`\\btestsuite\\s+(${NAME})`, 'u').exec(text)?.[1];
    if (!suite) {
      this.controller.items.delete(file.toString());
      return;
    }
    const item = this.controller.createTestItem(file.toString(), suite, file);
    item.description = vscode.workspace.asRelativePath(file);
    item.children.replace(testsIn(text).map((test) => this.item(file, test.name, test.line)));
    this.controller.items.add(item);
  }

  private item(file: vscode.Uri, name: string, line: number): vscode.TestItem {
    const item = this.controller.createTestItem(`${file}#${name}`, name, file);
    item.range = new vscode.Range(line, 0, line, 0);
    return item;
  }

  /**
   * Runs the suites of what is asked for, each as a whole: that takes as long as one of its tests.
   *
   * @param stepping whether the page of the runs is shown
   */
  async run(asked: vscode.TestRunRequest, stop: vscode.CancellationToken, stepping: boolean): Promise<void> {
    await saveAll();
    const run = this.controller.createTestRun(asked);
    const excluded = new Set(asked.exclude?.map((item) => item.id));
    for (const [suite, tests] of this.suites(asked)) {
      const wanted = tests.filter((test) => !excluded.has(test.id) && !excluded.has(suite.id));
      wanted.forEach((test) => run.started(test));
      if (suite.uri && wanted.length > 0 && !stop.isCancellationRequested) {
        await this.runSuite(run, suite.uri, wanted, stop, stepping);
      }
    }
    run.end();
  }

  private suites(asked: vscode.TestRunRequest): Map<vscode.TestItem, vscode.TestItem[]> {
    const suites = new Map<vscode.TestItem, vscode.TestItem[]>();
    const all: vscode.TestItem[] = [];
    this.controller.items.forEach((item) => all.push(item));
    for (const item of asked.include ?? all) {
      const suite = item.parent ?? item;
      const tests = suites.get(suite) ?? [];
      if (item.parent) {
        tests.push(item);
      } else {
        item.children.forEach((test) => tests.push(test));
      }
      suites.set(suite, [...new Set(tests)]);
    }
    return suites;
  }

  private async runSuite(
    run: vscode.TestRun,
    file: vscode.Uri,
    tests: readonly vscode.TestItem[],
    stop: vscode.CancellationToken,
    stepping: boolean,
  ): Promise<void> {
    const home = homeOf(file);
    const folder = await this.pages.folder('test');
    const report = stepping ? ['--report', folder] : [];
    try {
      const outcome = await this.tool.run(['test', '--format', 'json', ...report, ...(await withModels(file))], home, stop);
      tell(run, tests, outcome, (place) => path.resolve(home, place) === file.fsPath);
    } catch (e) {
      const reason = new vscode.TestMessage(e instanceof Error ? e.message : String(e));
      tests.forEach((test) => run.errored(test, reason));
    }
    if (stepping) {
      await this.pages.show('Stream tests', 'test', folder, home);
    }
  }
}

/** The suite, and the models that it is about where a build keeps them apart. */
async function withModels(file: vscode.Uri): Promise<string[]> {
  const root = modelRoot(file, await textOf(file));
  const models = root.replace(/([\\/])src\1test\1arc$/, '$1src$1main$1arc');
  return models === root || !existsSync(models) ? [file.fsPath] : [file.fsPath, models];
}

function testsIn(text: string): { name: string; line: number }[] {
  const found = text.matchAll(new RegExp(`(?<=[{};]\\s*)\\btest\\s+(${NAME})\\s*\\{`, 'gu'));
  return [...found].map((test) => ({
    name: test[1] ?? '',
    line: text.slice(0, test.index).split('\n').length - 1,
  }));
}
