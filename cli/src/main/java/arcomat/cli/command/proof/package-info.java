/** Questions that are answered for all runs: promises, contradictions, comparisons. */
package arcomat.cli.command.proof;
