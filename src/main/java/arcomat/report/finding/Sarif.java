package arcomat.report.finding;

import arcomat.report.finding.Reported.Standing;
import arcomat.report.text.Fields;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;
import arcomat.source.Diagnostic;
import arcomat.source.Diagnostic.Related;
import arcomat.source.Fix;
import arcomat.source.Fix.TextEdit;
import arcomat.source.RestOfFile;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;

/** Findings in SARIF 2.1.0, the exchange format of OASIS for what tools find in source texts. */
public final class Sarif {
    private static final String SCHEMA =
            "https://docs.oasis-open.org/sarif/sarif/v2.1.0/os/schemas/sarif-schema-2.1.0.json";

    private final SarifPlaces places;
    private final SarifRules rules;
    private final boolean compared;

    private Sarif(SarifPlaces places, SarifRules rules, boolean compared) {
        this.places = places;
        this.rules = rules;
        this.compared = compared;
    }

    /**
     * The tool that found something.
     *
     * @param version of Arcomat, as in {@code 1.2.3}
     * @param pages the page that explains a code, in Markdown
     */
    public record Tool(String version, Function<String, Optional<String>> pages) {}

    /**
     * @param compared whether findings were compared with a baseline
     */
    public static String render(
            List<Reported> results, boolean compared, Tool tool, SourceRoot root) {
        SarifRules rules = SarifRules.of(results, tool.pages());
        Sarif sarif = new Sarif(new SarifPlaces(root), rules, compared);
        Fields driver =
                Fields.of("name", "arcomat")
                        .with("version", tool.version())
                        .with("rules", rules.all(results));
        Fields run =
                Fields.of("tool", Fields.of("driver", driver))
                        .with("originalUriBaseIds", SarifPlaces.bases())
                        .with("columnKind", "utf16CodeUnits")
                        .with("invocations", sarif.invocations(results))
                        .with("results", results.stream().map(sarif::result).toList());
        return Json.text(
                Fields.of("$schema", SCHEMA).with("version", "2.1.0").with("runs", List.of(run)));
    }

    /** The run is told of only where it did not look at all of its files. */
    private Optional<List<Fields>> invocations(List<Reported> results) {
        List<Diagnostic> findings = results.stream().map(Reported::finding).toList();
        List<Fields> notes = RestOfFile.files(findings).stream().map(this::notLookedAt).toList();
        return unlessEmpty(notes)
                .map(
                        all ->
                                List.of(
                                        Fields.of("executionSuccessful", true)
                                                .with("toolExecutionNotifications", all)));
    }

    private Fields notLookedAt(String path) {
        Span place = new SourceFile(path, "").span(0, 0);
        String text = "the syntax of the rest of " + path + " was not looked at";
        return Fields.of("level", "warning")
                .with("message", SarifPlaces.message(text))
                .with("locations", List.of(places.location(place)));
    }

    private Fields result(Reported result) {
        Diagnostic finding = result.finding();
        return Fields.of("ruleId", finding.code())
                .with("ruleIndex", rules.index(finding.code()))
                .with("level", FindingsText.word(finding.severity()))
                .with("message", SarifPlaces.message(finding.message()))
                .with("locations", List.of(places.location(finding.span())))
                .with(
                        "partialFingerprints",
                        Fields.of("place/v1", Baseline.fingerprint(finding.span())))
                .with("relatedLocations", unlessEmpty(related(finding.related())))
                .with("codeFlows", unlessEmpty(result.steps()).map(this::flows))
                .with("fixes", finding.fix().map(fix -> List.of(change(fix))))
                .with("baselineState", baselineState(result.standing()))
                .with("suppressions", suppressions(result));
    }

    private static <T> Optional<List<T>> unlessEmpty(List<T> all) {
        return Optional.of(all).filter(each -> !each.isEmpty());
    }

    private List<Fields> related(List<Related> related) {
        return IntStream.range(0, related.size())
                .mapToObj(i -> related(i + 1, related.get(i)))
                .toList();
    }

    private Fields related(int id, Related related) {
        Fields fields = Fields.of("id", id);
        fields.putAll(places.location(related.span(), related.note()));
        return fields;
    }

    /** A run is one thread of one flow. */
    private List<Fields> flows(List<Reported.Step> steps) {
        List<Fields> locations =
                steps.stream()
                        .map(step -> places.location(step.place(), step.text()))
                        .map(location -> Fields.of("location", location))
                        .toList();
        return List.of(Fields.of("threadFlows", List.of(Fields.of("locations", locations))));
    }

    private Fields change(Fix fix) {
        Map<String, List<TextEdit>> byFile = new LinkedHashMap<>();
        for (TextEdit edit : fix.edits()) {
            byFile.computeIfAbsent(edit.span().file().path(), p -> new ArrayList<>()).add(edit);
        }
        return Fields.of("description", SarifPlaces.message(fix.title()))
                .with("artifactChanges", byFile.values().stream().map(this::change).toList());
    }

    private Fields change(List<TextEdit> edits) {
        return Fields.of("artifactLocation", places.file(edits.get(0).span()))
                .with("replacements", edits.stream().map(Sarif::replacement).toList());
    }

    private static Fields replacement(TextEdit edit) {
        return Fields.of("deletedRegion", SarifPlaces.region(edit.span()))
                .with("insertedContent", Fields.of("text", edit.text()));
    }

    /** What is suppressed in a model was not compared with a baseline. */
    private Optional<String> baselineState(Standing standing) {
        return Optional.of(standing == Standing.KNOWN ? "unchanged" : "new")
                .filter(any -> compared && standing != Standing.SUPPRESSED);
    }

    private static List<Fields> suppressions(Reported result) {
        return switch (result.standing()) {
            case NEW -> List.of();
            case SUPPRESSED -> List.of(suppression("inSource", result.reason()));
            case KNOWN -> List.of(suppression("external", "It is in the baseline."));
        };
    }

    private static Fields suppression(String kind, String reason) {
        return Fields.of("kind", kind).with("justification", Printable.escapeKeepingLayout(reason));
    }
}
