package arcomat.source;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Unicode's normal form C of names: an accent that stands behind its letter becomes one character
 * with it. Some file systems write file names apart, most keyboards write texts together. The
 * letters are those that names may have; Java's own normalizer is missing in browsers.
 */
public final class ComposedForm {
    private static final char FIRST_MARK = '\u0300';
    private static final char LAST_MARK = '\u036f';

    /** An accent, then letters, each with what it becomes. */
    private static final List<String> COMPOSITIONS =
            List.of(
                    "\u0300" + "AÀEÈIÌOÒUÙaàeèiìoòuùÜǛüǜNǸnǹЕЀИЍеѐиѝ",
                    "\u0301"
                        + "AÁEÉIÍOÓUÚYÝaáeéiíoóuúyýCĆcćLĹlĺNŃnńRŔrŕSŚsśZŹzźÜǗüǘGǴgǵÅǺåǻÆǼæǽØǾøǿΑΆΕΈΗΉΙΊΟΌΥΎΩΏϊΐαάεέηήιίϋΰοόυύωώϒϓГЃКЌгѓкќ",
                    "\u0302" + "AÂEÊIÎOÔUÛaâeêiîoôuûCĈcĉGĜgĝHĤhĥJĴjĵSŜsŝWŴwŵYŶyŷ",
                    "\u0303" + "AÃNÑOÕaãnñoõIĨiĩUŨuũ",
                    "\u0304" + "AĀaāEĒeēIĪiīOŌoōUŪuūÜǕüǖÄǞäǟȦǠȧǡÆǢæǣǪǬǫǭÖȪöȫÕȬõȭȮȰȯȱYȲyȳ",
                    "\u0306" + "AĂaăEĔeĕGĞgğIĬiĭOŎoŏUŬuŭУЎИЙийуў",
                    "\u0307" + "CĊcċEĖeėGĠgġIİZŻzżAȦaȧOȮoȯ",
                    "\u0308" + "AÄEËIÏOÖUÜaäeëiïoöuüyÿYŸΙΪΥΫιϊυϋϒϔЕЁІЇеёії",
                    "\u030a" + "AÅaåUŮuů",
                    "\u030b" + "OŐoőUŰuű",
                    "\u030c"
                        + "CČcčDĎdďEĚeěLĽlľNŇnňRŘrřSŠsšTŤtťZŽzžAǍaǎIǏiǐOǑoǒUǓuǔÜǙüǚGǦgǧKǨkǩƷǮʒǯjǰHȞhȟ",
                    "\u030f" + "AȀaȁEȄeȅIȈiȉOȌoȍRȐrȑUȔuȕѴѶѵѷ",
                    "\u0311" + "AȂaȃEȆeȇIȊiȋOȎoȏRȒrȓUȖuȗ",
                    "\u031b" + "OƠoơUƯuư",
                    "\u0326" + "SȘsșTȚtț",
                    "\u0327" + "CÇcçGĢgģKĶkķLĻlļNŅnņRŖrŗSŞsşTŢtţEȨeȩ",
                    "\u0328" + "AĄaąEĘeęIĮiįUŲuųOǪoǫ");

    private static final Map<String, Character> COMPOSED = composed();

    private ComposedForm() {}

    private static Map<String, Character> composed() {
        Map<String, Character> map = new HashMap<>();
        for (String row : COMPOSITIONS) {
            for (int i = 1; i < row.length(); i += 2) {
                map.put("" + row.charAt(i) + row.charAt(0), row.charAt(i + 1));
            }
        }
        return Map.copyOf(map);
    }

    /** The same text, with accents and their letters together where there is such a letter. */
    public static String of(String text) {
        if (firstMark(text) < 0) {
            return text;
        }
        StringBuilder result = new StringBuilder();
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            int last = result.length() - 1;
            Character both = last < 0 ? null : COMPOSED.get("" + result.charAt(last) + c);
            if (both == null) {
                result.append(c);
            } else {
                result.setCharAt(last, both);
            }
        }
        return result.toString();
    }

    /** Where a text has its first accent that stands alone; negative if it has none. */
    public static int firstMark(String text) {
        for (int i = 0; i < text.length(); i++) {
            if (text.charAt(i) >= FIRST_MARK && text.charAt(i) <= LAST_MARK) {
                return i;
            }
        }
        return -1;
    }
}
