/**
 * Finished tables of campaigns that ask the same, side by side: what differs between them by more
 * than chance. Knows rows, and not where they are kept.
 */
package arcomat.campaign.against;
