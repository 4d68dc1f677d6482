import * as vscode from 'vscode';
import { Assets } from './assets';
import { CommandLine } from './commandLine';
import { registerBrickCommands } from './brickCommands';
import { registerDiagram } from './diagramView';
import { LanguageServer } from './languageServer';
import { registerModelCommands } from './modelCommands';
import { ReportPages } from './reportPages';
import { registerProofCommands } from './proofCommands';
import { registerStreamTests } from './streamTests';
import { registerTasks } from './tasks';

/** Nothing is started in a folder that nobody trusts: what is started is a setting of that folder. */
export async function activate(context: vscode.ExtensionContext): Promise<void> {
  if (vscode.workspace.isTrusted) {
    await begin(context);
  } else {
    context.subscriptions.push(vscode.workspace.onDidGrantWorkspaceTrust(() => begin(context)));
  }
}

async function begin(context: vscode.ExtensionContext): Promise<void> {
  const output = vscode.window.createOutputChannel('Arcomat');
  const tool = new CommandLine(output);
  const assets = new Assets(context.extensionUri);
  const pages = new ReportPages(context, assets, tool);
  const server = new LanguageServer(tool, output, pages);
  context.subscriptions.push(
    output,
    server,
    ...registerModelCommands(tool, pages),
    ...registerProofCommands(tool, pages),
    ...registerBrickCommands(tool, pages),
    ...registerDiagram(assets, tool),
    registerStreamTests(tool, pages),
    registerTasks(tool),
    vscode.commands.registerCommand('arcomat.restart', () => server.restart()),
    vscode.workspace.onDidChangeConfiguration(async (change) => {
      if (change.affectsConfiguration('arcomat.path')) {
        await server.restart();
      }
    }),
  );
  await server.start();
}
