/** What a component is made of: parts, parameters, clauses, ancestors, behaviours. */
package arcomat.check.structure.component;
