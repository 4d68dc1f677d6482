package arcomat.check.behaviour.automaton;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.Needs.NAMES;
import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.executableError;
import static arcomat.check.law.Law.executableWarning;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class AutomatonLaws {
    public static final List<Law> LAWS =
            List.of(
                    warning("ARC0356", new BeginTogether()).needing(ALL),
                    error("ARC0324", new EmbeddedAutomatonInterface()),
                    error("ARC0315", new GuardIsBoolean()),
                    error("ARC0302", new InitialRequired()).needing(ALL),
                    error("ARC0310", new ItemOncePerBlock()),
                    error("ARC0320", new SingleEvent()).needing(ALL),
                    executableError("ARC0303", new SingleInitial()),
                    error("ARC0304", new StateExists()).needing(NAMES),
                    warning("ARC1003", new StateReached()).needing(ALL),
                    error("ARC0301", new StateRequired()).needing(ALL),
                    warning("ARC0349", new TransitionOnce()),
                    executableWarning("ARC1001", new TransitionsApart()).needing(ALL));

    private AutomatonLaws() {}
}
