/**
 * Standard input and output as people and other programs meet them: streams, tables that fit,
 * progress, dialogues, exit status, the last moment before a limit.
 */
package arcomat.cli.terminal;
