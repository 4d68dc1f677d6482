/**
 * What numbers of runs and columns of measures prove, and which numbers to try. It knows numbers
 * only: neither worlds nor campaigns. The same input gives the same bits on every machine: it
 * computes with StrictMath and with Hipparchus, which computes without the processor's own
 * functions; each draw is a function of a seed and of what it is for, so that nobody has to draw in
 * order.
 */
package arcomat.campaign.statistics;
