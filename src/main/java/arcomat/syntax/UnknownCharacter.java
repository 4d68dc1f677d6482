package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Signs;
import arcomat.source.Span;

/** A character that no word of the languages has. */
final class UnknownCharacter {
    private UnknownCharacter() {}

    /** The finding about the first character of a place. */
    static Diagnostic finding(Span place) {
        int sign = place.text().codePointAt(0);
        String message = "The character " + Signs.quoted(sign) + " has no meaning here. ";
        if (Signs.isBlank(sign)) {
            return Diagnostic.error(Codes.SYNTAX, place, message + "Put a space in its place.")
                    .withFix(Fix.replace("Put a space", place, " "));
        }
        Diagnostic finding = Diagnostic.error(Codes.SYNTAX, place, message + "Remove it.");
        return Signs.isUnseen(sign)
                ? finding.withFix(Fix.replace("Remove the character", place, ""))
                : finding;
    }
}
