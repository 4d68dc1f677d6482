import * as vscode from 'vscode';
import { CommandLine } from './commandLine';

const OFFERED: readonly (readonly string[])[] = [
  ['check', '.'],
  ['check', '--strict', '--profile', 'executable', '.'],
  ['test', '.'],
  ['verify', '.'],
];

/** Commands as tasks; findings go to the problems. */
export function registerTasks(tool: CommandLine): vscode.Disposable {
  return vscode.tasks.registerTaskProvider('arcomat', {
    provideTasks: () => OFFERED.map((words) => task(tool, { type: 'arcomat', arguments: words })),
    resolveTask: (given) => task(tool, given.definition),
  });
}

function task(tool: CommandLine, definition: vscode.TaskDefinition): vscode.Task {
  const words = (definition['arguments'] as readonly string[] | undefined) ?? [];
  const made = new vscode.Task(
    definition,
    vscode.TaskScope.Workspace,
    words.join(' '),
    'arcomat',
    new vscode.ProcessExecution(tool.program, tool.withLibraries(words)),
    ['$arcomat'],
  );
  made.group = words[0] === 'test' ? vscode.TaskGroup.Test : vscode.TaskGroup.Build;
  return made;
}
