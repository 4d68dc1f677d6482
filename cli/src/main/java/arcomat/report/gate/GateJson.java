package arcomat.report.gate;

import arcomat.analysis.evolution.Change;
import arcomat.analysis.evolution.Gate;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.report.campaign.CampaignVerdict;
import arcomat.report.finding.FindingsJson;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;
import arcomat.report.verdict.VerdictJson;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.annotation.JsonUnwrapped;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** What became of every component, unchanged ones included, for programs. */
public record GateJson(
        String verdict,
        List<Entry> components,
        Optional<List<CampaignVerdict>> campaigns,
        List<FindingsJson.Finding> findings,
        Optional<List<String>> leftOut) {

    record Entry(
            String name,
            String relation,
            String reason,
            Optional<String> excuse,
            Optional<String> cause,
            Optional<Place> old,
            @JsonProperty("new") Optional<Place> fresh,
            List<Witness> witnesses) {
        static Entry of(Gate.Entry entry) {
            return new Entry(
                    entry.name(),
                    Printable.word(entry.change().relation()),
                    entry.change().reason(),
                    entry.excuse(),
                    entry.cause(),
                    entry.old().map(Place::of),
                    entry.fresh().map(Place::of),
                    entry.change().witnesses().stream().map(Witness::of).toList());
        }
    }

    record Place(String file, int line, int column) {
        static Place of(Span span) {
            return new Place(
                    span.file().path(), span.startPosition().line(), span.startPosition().column());
        }
    }

    record Witness(String left, String right, @JsonUnwrapped VerdictJson verdict) {
        static Witness of(Change.Witness each) {
            return new Witness(each.left(), each.right(), VerdictJson.of(each.verdict()));
        }
    }

    /**
     * The same as text.
     *
     * @param unread findings about files that are left out
     * @param leftOut their paths
     */
    public static String render(
            Gate gate,
            GatedCampaigns campaigns,
            List<Diagnostic> findings,
            List<Diagnostic> unread,
            List<String> leftOut) {
        Answer whole = gate.answer().and(campaigns.answer());
        Answer answer = leftOut.isEmpty() ? whole : whole.and(Answer.UNKNOWN);
        return Json.text(
                new GateJson(
                        Printable.word(answer),
                        gate.entries().stream().map(Entry::of).toList(),
                        campaigns.verdicts(),
                        Stream.concat(unread.stream(), findings.stream())
                                .map(FindingsJson.Finding::of)
                                .toList(),
                        Optional.of(leftOut).filter(paths -> !paths.isEmpty())));
    }
}
