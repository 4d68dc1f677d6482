package montiarc7.source;

import arcomat.guest.Transcription;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;

import java.util.LinkedHashSet;
import java.util.Set;
import java.util.regex.Pattern;

/** What is wrong with one file: the first thing that is missing, and how much more there is. */
public final class Lacks {
    private record Told(Lack lack, Span place, String message) {}

    private static final Pattern FLOATING =
            Pattern.compile("\\b([dD]ouble|[fF]loat)\\b|[0-9]\\.[0-9]");

    private final SourceFile file;
    private final Transcription transcription;
    private final Set<Told> notes = new LinkedHashSet<>();
    private final Set<Told> missing = new LinkedHashSet<>();

    public Lacks(SourceFile file, Transcription transcription) {
        this.file = file;
        this.transcription = transcription;
    }

    /** Of the same file, where what is wrong is told by somebody else. */
    public Lacks unheard() {
        return new Lacks(file, transcription);
    }

    /** Whether the file does not speak of Double or float. */
    public boolean hasWholeNumbersOnly() {
        return !FLOATING.matcher(file.text()).find();
    }

    /** Whether the file has a word. */
    public boolean says(String word) {
        return Pattern.compile("\\b" + Pattern.quote(word) + "\\b").matcher(file.text()).find();
    }

    public boolean isAny() {
        return !missing.isEmpty();
    }

    public Span whole() {
        return file.span(0, 0);
    }

    public void missing(Lack lack, ParserRuleContext place, String message) {
        missing(lack, span(place), message);
    }

    public void missing(Lack lack, Span place, String message) {
        missing.add(new Told(lack, place, message));
    }

    /** Says what somebody has to know of a file that is converted. */
    public void note(Lack lack, ParserRuleContext place, String message) {
        notes.add(new Told(lack, span(place), message));
    }

    /** Whether the file cannot be converted; this is told once. */
    public boolean tell() {
        if (missing.isEmpty()) {
            notes.forEach(
                    each -> transcription.note(each.lack().code(), each.place(), each.message()));
            notes.clear();
            return false;
        }
        Told first = missing.iterator().next();
        int count = missing.size();
        String more =
                count == 1 ? "" : "; there is more that cannot be converted (" + count + " in all)";
        transcription.missing(first.lack().code(), first.place(), first.message() + more);
        return true;
    }

    Span span(ParserRuleContext place) {
        int start = place.getStart().getStartIndex();
        Token stop = place.getStop() == null ? place.getStart() : place.getStop();
        return offsets(start, Math.max(start, stop.getStopIndex() + 1)).firstLine();
    }

    /** ANTLR counts code points, and places count UTF-16 units. */
    public Span offsets(int start, int end) {
        String text = file.text();
        int from =
                text.offsetByCodePoints(0, Math.min(start, text.codePointCount(0, text.length())));
        int to = text.offsetByCodePoints(0, Math.min(end, text.codePointCount(0, text.length())));
        return file.span(from, Math.max(from, to));
    }
}
