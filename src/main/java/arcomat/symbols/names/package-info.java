/**
 * What files define under which names, and what a name reaches from where it stands: components by
 * their declarations, and the types of messages. The first step, as javac's Enter; knows nothing of
 * what a component has.
 */
package arcomat.symbols.names;
