/** Names that lead to other definitions: imports, types, components and their type arguments. */
package arcomat.check.structure.reference;
