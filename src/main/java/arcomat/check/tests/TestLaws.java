package arcomat.check.tests;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.Needs.NAMES;
import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class TestLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0707", new EventsForUntimedOnly()).needing(ALL),
                    error("ARC0705", new TestArguments()),
                    warning("ARC0708", new TestFieldUnsupported()).needing(NAMES),
                    error("ARC0703", new TestMessageType()),
                    error("ARC0704", new TestNamesUnique()),
                    error("ARC0702", new TestPortExists()).needing(NAMES),
                    error("ARC0706", new TestSingleMessagePerSlice()),
                    error("ARC0710", new TestStreamLength()),
                    error("ARC0709", new TestStreamOnce()),
                    error("ARC0701", new TestedComponentExists()));

    private TestLaws() {}
}
