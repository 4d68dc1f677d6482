package arcomat.laws;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.laws.draw.Plug;
import arcomat.model.Component;
import arcomat.models.ReadModels;
import arcomat.pipeline.compile.Agreement;
import arcomat.source.Severity;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;

/** Interpreter and compiled code do the same, letter by letter. */
final class EnginesAgree implements Law {
    private static final int WORDS = 6;
    private static final int LETTERS = 12;

    @Override
    public String name() {
        return "7 engines agree";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        boolean events = draw.has(Features.EVENTS) && draw.chance(25);
        List<Plug> plugs = ComponentText.plugs(draw, events);
        List<SourceFile> files = new ArrayList<>(List.of(ComponentText.types()));
        if (draw.has(Features.COMPOSITIONS) && draw.chance(50)) {
            List<Plug> open = ComponentText.withoutTotalOutputs(plugs);
            files.addAll(ComponentText.composite(draw, "a", "Main", open, events, 0));
        } else {
            files.add(ComponentText.atomic(draw, "a", "Main", plugs, events, 1));
        }
        return files;
    }

    /** Code can be generated only from models that say enough. */
    @Override
    public Outcome check(Models models) {
        boolean executable =
                Checks.run(ReadModels.workspace(models.files()), Profile.EXECUTABLE).stream()
                        .noneMatch(finding -> finding.severity() == Severity.ERROR);
        if (!executable) {
            return Outcome.SKIPPED;
        }
        Component component = models.component(Pairs.LEFT);
        try {
            new Agreement(component, List.of()).holds(WORDS, LETTERS);
            return Outcome.KEPT;
        } catch (AssertionError differ) {
            return Outcome.broken(
                    "engines differ: " + differ.getMessage(),
                    "simulate --engine interpreter " + Pairs.LEFT,
                    "simulate --engine compiled " + Pairs.LEFT);
        }
    }
}
