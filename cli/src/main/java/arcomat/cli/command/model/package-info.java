/** Models as texts: what is wrong with them, what that means, how they look. */
package arcomat.cli.command.model;
