/** Commands that other programs start and talk to. */
package arcomat.cli.command.serve;
