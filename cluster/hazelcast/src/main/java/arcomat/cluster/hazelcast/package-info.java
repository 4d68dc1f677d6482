/**
 * Campaigns made by workers in other processes, on this machine or on many. The process of the
 * campaign is the only member of a Hazelcast cluster; workers are its clients: they open no port,
 * know nothing of each other and keep nothing, so that one of them may come or be killed at any
 * moment. Which run is where is known to the campaign alone: what a worker has not answered when
 * its connection is gone is given to others.
 */
package arcomat.cluster.hazelcast;
