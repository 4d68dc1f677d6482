package arcomat.editor.answer.completion;

import arcomat.pipeline.beside.BesideText.Choice;

import java.util.List;

/**
 * A piece of a world, a campaign or a script to be filled in.
 *
 * @param ending of the names of files that it is for
 * @param skeleton its word is that of a line; empty for a text that nothing stands in yet
 */
record LineSkeleton(String ending, Skeleton skeleton) {
    private static final String WHOLE = "";

    static final List<LineSkeleton> ALL =
            List.of(
                    of(
                            ".world",
                            WHOLE,
                            "floor, kind, robot",
                            "a world with one robot",
                            """
                            floor ${1:2000} ${2:1000}
                            seconds ${3:30}

                            kind ${4:rover}
                              program component ${5:p.Rover} in ${6:.}
                              wheels A B

                            robot ${7:one} ${4:rover} at ${8:300} ${9:500}
                            $0\
                            """),
                    of(
                            ".world",
                            "kind",
                            "kind ...",
                            "a kind of robots: program, wheels, a sensor",
                            """
                            kind ${1:rover}
                              program component ${2:p.Rover} in ${3:.}
                              wheels A B
                              ultrasonic S1 at ${4:75} ${5:0}
                            $0\
                            """),
                    of(
                            ".world",
                            "robot",
                            "robot ... at",
                            "a robot at a place, in mm",
                            "robot ${1:one} ${2:rover} at ${3:300} ${4:500} heading ${5:0}$0"),
                    of(
                            ".campaign",
                            WHOLE,
                            "world, sample, require",
                            "runs of a world, and what they have to show",
                            """
                            world ${1:robot.world}

                            sample random ${2:1000}
                            stop decided

                            require ${3:collision} below ${4:0.01} at ${5:95}
                            $0\
                            """),
                    of(
                            ".campaign",
                            "vary",
                            "vary ... from",
                            "a parameter of the world that varies",
                            "vary ${1:light} from ${2:0} to ${3:3}$0"),
                    of(
                            ".campaign",
                            "require",
                            "require ... below",
                            "how rare an event has to be",
                            "require ${1:collision} below ${2:0.01} at ${3:95}$0"),
                    of(
                            ".script",
                            WHOLE,
                            "times",
                            "what the sensors of a brick see, in milliseconds",
                            """
                            0     S1 ${1:100}
                            ${2:1000}  S4 ${3:pressed}
                            ${4:3000}  end
                            $0\
                            """));

    private static LineSkeleton of(
            String ending, String word, String label, String detail, String text) {
        return new LineSkeleton(ending, new Skeleton(word, label, detail, text));
    }

    /**
     * Those that may stand at the beginning of a line.
     *
     * @param isAlone whether nothing else stands in the text
     * @param choices words that may stand there
     */
    static List<Skeleton> fitting(String path, boolean isAlone, List<Choice> choices) {
        List<String> words = choices.stream().map(Choice::word).toList();
        return ALL.stream()
                .filter(each -> path.endsWith(each.ending()))
                .map(LineSkeleton::skeleton)
                .filter(each -> each.word().isEmpty() ? isAlone : words.contains(each.word()))
                .toList();
    }
}
