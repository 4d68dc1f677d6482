/** Where connectors lead, and which ports they reach. */
package arcomat.check.structure.connector;
