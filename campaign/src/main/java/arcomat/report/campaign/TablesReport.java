package arcomat.report.campaign;

import arcomat.campaign.against.FinishedTable;
import arcomat.campaign.against.TableDifference;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** A finished table beside an older one, for whoever wants to know what has changed. */
public record TablesReport(FinishedTable before, FinishedTable now, TableDifference difference) {
    /** What one has to know of the comparison; for people. */
    List<String> remarks() {
        List<String> remarks = new ArrayList<>();
        if (!difference.others().isEmpty()) {
            remarks.add(
                    "not compared, since they do not ask for it in the same words: "
                            + String.join(", ", difference.others()));
        }
        Stream.of(before, now)
                .filter(FinishedTable::endedEarly)
                .forEach(
                        each ->
                                remarks.add(
                                        ("nothing is concluded: '%s' ended before its %,d runs, as"
                                                        + " soon as its answer was clear")
                                                .formatted(each.name(), each.planned())));
        if (!difference.isPaired() && difference.pairs() > 0) {
            remarks.add("too few runs are of both to go by them: intervals decide");
        } else if (!difference.isPaired()) {
            remarks.add("no run is of both: intervals decide");
        }
        return remarks;
    }
}
