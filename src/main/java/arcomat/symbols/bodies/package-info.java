/**
 * What stands in components: parts, connectors, automata, tables, and in stream tests; delays
 * through all of it. The third step, as javac's Attr.
 */
package arcomat.symbols.bodies;
