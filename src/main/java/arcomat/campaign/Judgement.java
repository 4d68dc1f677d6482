package arcomat.campaign;

import arcomat.campaign.statistics.Decision;

/**
 * What a campaign says of one of its demands, or of its comparison.
 *
 * @param subject in the words of the campaign
 * @param isDemand whether somebody asked for it; a comparison that shows no difference is fine
 * @param because figures, in a clause for people
 */
public record Judgement(String subject, boolean isDemand, Decision decision, String because) {}
