/**
 * Trace inclusion between two systems by the product of one with the macro states of the other, cut
 * short by an antichain and a simulation (De Wulf, Doyen, Henzinger, Raskin, "Antichains: a new
 * algorithm for checking universality of finite automata", CAV 2006; Abdulla, Chen, Holík, Mayr,
 * Vojnar, "When simulation meets antichains", TACAS 2010); and certificates that say why it holds,
 * which are checked by a second look.
 */
package arcomat.analysis.search.product;
