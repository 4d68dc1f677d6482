import * as vscode from 'vscode';
import { LanguageClient, LanguageClientOptions } from 'vscode-languageclient/node';
import { CommandLine, tellMissing } from './commandLine';
import { LANGUAGES } from './models';

/** `arcomat language-server`, which finds, mends, completes, renames and formats. */
export class LanguageServer implements vscode.Disposable {
  private client: LanguageClient | undefined;

  constructor(
    private readonly tool: CommandLine,
    private readonly output: vscode.OutputChannel,
  ) {}

  async start(): Promise<void> {
    const version = await this.tool.version();
    await vscode.commands.executeCommand('setContext', 'arcomat.found', version !== undefined);
    if (version === undefined) {
      void tellMissing(`'${this.tool.program}' is not there, or is no Arcomat`);
      return;
    }
    this.output.appendLine(version);
    const client = new LanguageClient('arcomat', 'Arcomat', this.server(), this.options());
    this.client = client;
    await client.start();
  }

  private server(): { command: string; args: string[] } {
    return { command: this.tool.program, args: ['language-server'] };
  }

  private options(): LanguageClientOptions {
    return {
      documentSelector: Object.values(LANGUAGES).map((language) => ({ scheme: 'file', language })),
      outputChannel: this.output,
    };
  }

  async restart(): Promise<void> {
    const old = this.client;
    this.client = undefined;
    await old?.dispose();
    await this.start();
  }

  dispose(): void {
    void this.client?.dispose();
  }
}
