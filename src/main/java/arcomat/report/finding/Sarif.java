package arcomat.report.finding;

import arcomat.report.finding.Reported.Standing;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.TextEdit;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonProperty;

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

    private record Log(@JsonProperty("$schema") String schema, String version, List<Run> runs) {}

    private record Run(
            Map<String, Driver> tool,
            Map<String, ?> originalUriBaseIds,
            String columnKind,
            List<Result> results) {}

    private record Driver(String name, String version, List<SarifRules.Rule> rules) {}

    private record Result(
            String ruleId,
            int ruleIndex,
            String level,
            SarifPlaces.Message message,
            List<SarifPlaces.Location> locations,
            Map<String, String> partialFingerprints,
            @JsonInclude(JsonInclude.Include.NON_EMPTY) List<SarifPlaces.Location> relatedLocations,
            Optional<List<?>> codeFlows,
            Optional<List<Change>> fixes,
            Optional<String> baselineState,
            List<Suppression> suppressions) {}

    private record Change(SarifPlaces.Message description, List<FileChange> artifactChanges) {}

    private record FileChange(SarifPlaces.File artifactLocation, List<Replacement> replacements) {}

    private record Replacement(
            SarifPlaces.Region deletedRegion, Map<String, String> insertedContent) {}

    private record Suppression(String kind, String justification) {}

    /**
     * @param compared whether findings were compared with a baseline
     */
    public static String render(
            List<Reported> results, boolean compared, Tool tool, SourceRoot root) {
        SarifRules rules = SarifRules.of(results, tool.pages());
        Sarif sarif = new Sarif(new SarifPlaces(root), rules, compared);
        Driver driver = new Driver("arcomat", tool.version(), rules.all(results));
        Run run =
                new Run(
                        Map.of("driver", driver),
                        SarifPlaces.bases(),
                        "utf16CodeUnits",
                        results.stream().map(sarif::result).toList());
        return Json.text(new Log(SCHEMA, "2.1.0", List.of(run)));
    }

    private Result result(Reported result) {
        Diagnostic finding = result.finding();
        return new Result(
                finding.code(),
                rules.index(finding.code()),
                SarifRules.level(finding),
                SarifPlaces.message(finding.message()),
                List.of(places.location(finding.span())),
                Map.of("place/v1", Baseline.fingerprint(finding.span())),
                IntStream.range(0, finding.related().size())
                        .mapToObj(i -> places.related(i + 1, finding.related().get(i)))
                        .toList(),
                Optional.of(result.steps()).filter(all -> !all.isEmpty()).map(this::flows),
                finding.fix().map(fix -> List.of(change(fix))),
                baselineState(result.standing()),
                suppressions(result));
    }

    /** A run is one thread of one flow. */
    private List<?> flows(List<Reported.Step> steps) {
        List<?> locations =
                steps.stream()
                        .map(step -> places.location(step.place(), step.text()))
                        .map(location -> Map.of("location", location))
                        .toList();
        return List.of(Map.of("threadFlows", List.of(Map.of("locations", locations))));
    }

    private Change change(Fix fix) {
        Map<String, List<TextEdit>> byFile = new LinkedHashMap<>();
        for (TextEdit edit : fix.edits()) {
            byFile.computeIfAbsent(edit.span().file().path(), p -> new ArrayList<>()).add(edit);
        }
        return new Change(
                SarifPlaces.message(fix.title()),
                byFile.values().stream().map(this::change).toList());
    }

    private FileChange change(List<TextEdit> edits) {
        return new FileChange(
                places.file(edits.get(0).span()),
                edits.stream()
                        .map(
                                edit ->
                                        new Replacement(
                                                SarifPlaces.Region.of(edit.span()),
                                                Map.of("text", edit.text())))
                        .toList());
    }

    /** What is suppressed in a model was not compared with a baseline. */
    private Optional<String> baselineState(Standing standing) {
        return Optional.of(standing == Standing.KNOWN ? "unchanged" : "new")
                .filter(any -> compared && standing != Standing.SUPPRESSED);
    }

    private static List<Suppression> suppressions(Reported result) {
        return switch (result.standing()) {
            case NEW -> List.of();
            case SUPPRESSED -> List.of(suppression("inSource", result.reason()));
            case KNOWN -> List.of(suppression("external", "It is in the baseline."));
        };
    }

    private static Suppression suppression(String kind, String reason) {
        return new Suppression(kind, Printable.escapeKeepingLayout(reason));
    }
}
