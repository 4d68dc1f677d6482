/**
 * Safety of systems whose states are bits, decided without looking at states one by one: a small
 * satisfiability solver, property directed reachability on top of it, and a check of the invariants
 * that come out, which trusts neither. Knows no models.
 */
package arcomat.analysis.symbolic;
