/**
 * Campaigns made by Apache Spark, for laboratories that have it: the command {@code arcomat
 * campaign} inside a program for {@code spark-submit}. The driver plans, judges and writes as the
 * command does elsewhere; tasks make runs. What comes back is bytes of a form of our own.
 */
package arcomat.cluster.spark;
