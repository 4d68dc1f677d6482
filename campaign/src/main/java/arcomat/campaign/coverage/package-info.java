/**
 * What the runs of a campaign cover: which transitions of the robots' automata were taken, in which
 * states they were, and what none of them came to. Knows numbers and places in models, and no runs.
 */
package arcomat.campaign.coverage;
