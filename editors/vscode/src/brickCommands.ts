import * as path from 'node:path';
import * as vscode from 'vscode';
import { CommandLine, FINE, register } from './commandLine';
import { Definition, homeOf, MADE, modelRoot, saveAll, shownOrPicked, textOf, withArguments } from './models';
import { ReportPages } from './reportPages';

/** Commands that make programs for the brick and run them on a simulated one. */
export function registerBrickCommands(tool: CommandLine, pages: ReportPages): vscode.Disposable[] {
  return [
    register('arcomat.jar', () => makeJar(tool)),
    register('arcomat.brick', () => runOnBrick(tool, pages)),
  ];
}

async function makeJar(tool: CommandLine): Promise<void> {
  const robot = await shownOrPicked('Which robot?');
  const home = robot && homeOf(robot.file);
  if (home) {
    await generate(tool, robot, path.join(home, 'build', 'brick', simpleName(robot)));
  }
}

async function runOnBrick(tool: CommandLine, pages: ReportPages): Promise<void> {
  const robot = await shownOrPicked('Which robot?');
  const script = robot && (await pickScript());
  if (!robot || !script) {
    return;
  }
  const folder = await pages.folder('jar');
  if (await generate(tool, robot, folder)) {
    const words = ['run-brick', '--jar', path.join(folder, `${simpleName(robot)}.jar`), ...script];
    await pages.run(`Brick: ${simpleName(robot)}`, 'brick', words, homeOf(robot.file));
  }
}

/** Whether there is a jar now; if not, it was told why. */
async function generate(tool: CommandLine, robot: Definition, folder: string): Promise<boolean> {
  const main = await withArguments(robot);
  if (!main) {
    return false;
  }
  await saveAll();
  const root = modelRoot(robot.file, await textOf(robot.file));
  const words = ['generate', '--target', 'lejos', '--out', folder, '--main', main, root];
  const outcome = await tool.show(`Generating ${simpleName(robot)}.jar`, words, homeOf(robot.file));
  if (outcome) {
    void tool.tell(outcome);
  }
  return outcome?.status === FINE;
}

function simpleName(robot: Definition): string {
  return robot.qualifiedName.slice(robot.qualifiedName.lastIndexOf('.') + 1);
}

interface ScriptPick extends vscode.QuickPickItem {
  readonly words: string[];
}

/** The script of the editor stands first; without one, nothing happens to the brick. */
async function pickScript(): Promise<string[] | undefined> {
  const shown = vscode.window.activeTextEditor?.document.uri.toString();
  const files = await vscode.workspace.findFiles('**/*.script', MADE);
  const picks: ScriptPick[] = files
    .sort((a, b) => a.fsPath.localeCompare(b.fsPath))
    .sort((a, b) => Number(b.toString() === shown) - Number(a.toString() === shown))
    .map((file) => ({ label: vscode.workspace.asRelativePath(file), words: ['--script', file.fsPath] }));
  picks.push({ label: 'no script', description: 'nothing happens to the brick, for 60 s', words: ['--seconds', '60'] });
  return (await vscode.window.showQuickPick(picks, { title: 'What happens to the brick?' }))?.words;
}
