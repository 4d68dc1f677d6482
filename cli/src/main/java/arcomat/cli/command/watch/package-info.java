/** The command that stays: what is broken, on a screen or in lines, at each save. */
package arcomat.cli.command.watch;
