package arcomat.report.verdict;

import arcomat.analysis.evolution.Evolution;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;
import arcomat.source.Span;

import com.fasterxml.jackson.annotation.JsonUnwrapped;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** The matrix of verdicts along versions, for programs; versions are counted from 1. */
public record EvolutionJson(List<Version> versions, List<Break> breaks) {
    record Version(String name, List<String> refines) {
        static Version of(Evolution evolution, int index) {
            return new Version(
                    evolution.titles().get(index),
                    evolution.verdicts().get(index).stream()
                            .map(verdict -> Printable.word(verdict.answer()))
                            .toList());
        }
    }

    record Break(int version, int promise, @JsonUnwrapped VerdictJson verdict, List<Edit> edits) {
        static Break of(Evolution.Break each) {
            return new Break(
                    each.version() + 1,
                    each.promise() + 1,
                    VerdictJson.of(each.verdict()),
                    each.culprits().stream()
                            .map(
                                    edit ->
                                            new Edit(
                                                    edit.old().map(Text::of),
                                                    edit.fresh().map(Text::of)))
                            .toList());
        }
    }

    record Edit(Optional<Text> was, Optional<Text> is) {}

    record Text(String text, String file, int line) {
        static Text of(Span span) {
            return new Text(span.text(), span.file().path(), span.startPosition().line());
        }
    }

    public static String render(Evolution evolution) {
        return Json.text(
                new EvolutionJson(
                        IntStream.range(0, evolution.titles().size())
                                .mapToObj(index -> Version.of(evolution, index))
                                .toList(),
                        evolution.breaks().stream().map(Break::of).toList()));
    }
}
