/** What is written from models: programs, monitors, tests; and what the brick says to it. */
package arcomat.cli.command.code;
