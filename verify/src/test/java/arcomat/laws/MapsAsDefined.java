package arcomat.laws;

import arcomat.analysis.map.InterfaceMap;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.MapText;
import arcomat.laws.naive.NaiveWords;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/**
 * What is said of a refinement through a map is what its definition says, word by word: all that
 * the map makes of what the first component shows is shown by the second one, for all that the map
 * makes of the inputs.
 */
final class MapsAsDefined implements Law {
    private static final int SLICES = 3;
    private static final String COMMAND = "refines --map m.Map m.A m.B";

    @Override
    public String name() {
        return "10 maps as defined";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        return MapText.of(draw);
    }

    @Override
    public Outcome check(Models models) {
        Verdict verdict = verdict(models);
        boolean compared = verdict.reason().isEmpty() || verdict.reason().equals("behaviour");
        if (verdict.answer() == Answer.UNKNOWN || !compared) {
            return Outcome.SKIPPED;
        }
        try {
            OptionalInt violation = violation(models);
            int found =
                    verdict.answer() == Answer.FAILS ? verdict.trace().size() : Integer.MAX_VALUE;
            boolean missed = violation.isPresent() && verdict.answer() != Answer.FAILS;
            boolean invented = violation.isEmpty() && found <= SLICES;
            return missed || invented
                    ? Outcome.broken(
                            Questions.text(verdict) + ", but by definition: " + violation, COMMAND)
                    : Outcome.KEPT;
        } catch (NaiveWords.NoWords | IllegalStateException none) {
            return Outcome.SKIPPED;
        }
    }

    static Verdict verdict(Models models) {
        InterfaceMap map =
                new InterfaceMap(
                        "m.Map",
                        Optional.of(promise("m.Inputs", models)),
                        Optional.of(promise("m.Outputs", models)));
        return map.check(promise("m.A", models), promise("m.B", models), Questions.budget());
    }

    private static Promise promise(String name, Models models) {
        return Questions.promise(models.component(name));
    }

    /** The number of slices that show it. */
    private static OptionalInt violation(Models models) {
        NaiveWords concrete = new NaiveWords(models.component("m.A"));
        NaiveWords wanted = new NaiveWords(models.component("m.B"));
        NaiveWords inputs = new NaiveWords(models.component("m.Inputs"));
        NaiveWords outputs = new NaiveWords(models.component("m.Outputs"));
        for (int slices = 1; slices <= SLICES; slices++) {
            for (List<Map<String, Value>> word :
                    NaiveWords.inputs(models.component("m.A"), slices)) {
                for (List<Map<String, Value>> sent : concrete.answers(word)) {
                    for (List<Map<String, Value>> seen : outputs.answers(joined(word, sent))) {
                        for (List<Map<String, Value>> read : inputs.answers(word)) {
                            if (!wanted.answers(read).contains(seen)) {
                                return OptionalInt.of(slices);
                            }
                        }
                    }
                }
            }
        }
        return OptionalInt.empty();
    }

    private static List<Map<String, Value>> joined(
            List<Map<String, Value>> one, List<Map<String, Value>> two) {
        return IntStream.range(0, one.size())
                .mapToObj(
                        i -> {
                            Map<String, Value> both = new HashMap<>(one.get(i));
                            both.putAll(two.get(i));
                            return both;
                        })
                .toList();
    }
}
