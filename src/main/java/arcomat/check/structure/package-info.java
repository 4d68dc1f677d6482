/** Laws about components, ports, parts and connectors: ARC01. */
package arcomat.check.structure;
