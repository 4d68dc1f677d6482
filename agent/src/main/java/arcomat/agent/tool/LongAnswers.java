package arcomat.agent.tool;

import arcomat.pipeline.WrongUse;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * Answers that are too long for one message, in parts, the last few of them: who asks for the rest
 * gets the rest of what he has begun to read, whatever has become of the models.
 */
public final class LongAnswers {
    private static final int MOST = 8;

    private final int longest;
    private final Deque<Kept> kept = new ArrayDeque<>();
    private int last;

    /**
     * @param longest characters of a part
     */
    public LongAnswers(int longest) {
        this.longest = longest;
    }

    /**
     * A part of an answer.
     *
     * @param number of the answer, by which the rest is asked for
     */
    private record Kept(int number, List<String> parts) {
        /**
         * @param part from 1
         */
        ToolAnswer part(int part, List<String> remarks) {
            List<String> all = new ArrayList<>(List.of(remark(part)));
            all.addAll(remarks);
            return new ToolAnswer(parts.get(part - 1), all);
        }

        private String remark(int part) {
            String which = "This is part " + part + " of " + parts.size() + ", cut by its length. ";
            return part == parts.size()
                    ? which + "There is no more."
                    : which
                            + "Call the tool 'rest' with answer "
                            + number
                            + " and part "
                            + (part + 1)
                            + " for what follows, or ask for less.";
        }
    }

    /** An answer as it is, or its first part with a word about the others. */
    public synchronized ToolAnswer begin(ToolAnswer answer) {
        List<String> parts = parts(answer.text(), longest);
        if (parts.size() == 1) {
            return answer;
        }
        Kept fresh = new Kept(++last, parts);
        kept.addLast(fresh);
        if (kept.size() > MOST) {
            kept.removeFirst();
        }
        return fresh.part(1, answer.remarks());
    }

    /**
     * @param part from 1
     * @throws WrongUse where there is no such part, or not any more
     */
    synchronized ToolAnswer part(long number, long part) throws WrongUse {
        for (Kept each : kept) {
            if (each.number() == number) {
                if (part < 1 || part > each.parts().size()) {
                    throw new WrongUse(
                            "answer %d has no part %d, but %d parts",
                            number, part, each.parts().size());
                }
                return each.part((int) part, List.of());
            }
        }
        throw new WrongUse(
                "answer %d is not kept any more, or never was; ask again what it answered", number);
    }

    /** Behind the end of a line, where there is one in the second half of a part. */
    static List<String> parts(String text, int longest) {
        List<String> parts = new ArrayList<>();
        int from = 0;
        while (text.length() - from > longest) {
            int line = text.lastIndexOf('\n', from + longest - 1) + 1;
            int to = line > from + longest / 2 ? line : from + longest;
            if (Character.isHighSurrogate(text.charAt(to - 1))) {
                to--;
            }
            parts.add(text.substring(from, to));
            from = to;
        }
        parts.add(text.substring(from));
        return List.copyOf(parts);
    }
}
