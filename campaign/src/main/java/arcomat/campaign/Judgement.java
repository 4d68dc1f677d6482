package arcomat.campaign;

import arcomat.campaign.statistics.Decision;
import arcomat.source.Span;

/**
 * What a campaign says of one of its demands, or of its comparison.
 *
 * @param subject in the words of the campaign
 * @param isDemand whether somebody asked for it; a comparison that shows no difference is fine
 * @param because figures, in a clause for people
 * @param place where the campaign asks for it
 */
public record Judgement(
        String subject, boolean isDemand, Decision decision, String because, Span place) {
    /** What is said of it: the comparison's words are better and worse. */
    public String word() {
        return switch (decision) {
            case HOLDS -> isDemand ? "holds" : "better";
            case FAILS -> isDemand ? "fails" : "worse";
            case UNDECIDED -> isDemand ? "unknown" : "compared";
        };
    }

    /** Whether it keeps from going on: a comparison that shows no difference does not. */
    public boolean isOpen() {
        return isDemand && decision == Decision.UNDECIDED;
    }
}
