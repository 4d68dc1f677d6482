/**
 * Whether one component keeps what another one promises: the verdict, the shortest trace that
 * breaks it with its reasons, what of it was met, and a certificate.
 */
package arcomat.analysis.refinement;
