/** Models that run: one after another, on bricks, on a floor, many times. */
package arcomat.cli.command.run;
