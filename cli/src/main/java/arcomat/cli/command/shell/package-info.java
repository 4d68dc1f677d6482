/** What a shell and its manual are told about the commands, from the commands' own help. */
package arcomat.cli.command.shell;
