package arcomat.campaign;

/**
 * What a search for the worst case has found: the worst of the runs that it made, and not of all
 * that there could be.
 *
 * @param search what was looked for
 * @param row the first of the worst runs
 * @param value its number
 * @param runs how many were made
 * @param searches how often it began somewhere else, the first time included
 */
public record WorstRun(Campaign.Search search, Row row, double value, int runs, int searches) {
    /** As the campaign says it: smallest or largest. */
    public String which() {
        return search.side() == Demand.Side.BELOW ? "smallest" : "largest";
    }
}
