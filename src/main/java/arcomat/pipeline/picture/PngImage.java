package arcomat.pipeline.picture;

import arcomat.pipeline.WrongUse;

import com.github.weisj.jsvg.SVGDocument;
import com.github.weisj.jsvg.parser.LoaderContext;
import com.github.weisj.jsvg.parser.SVGLoader;
import com.github.weisj.jsvg.view.FloatSize;

import java.awt.AWTError;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

import javax.imageio.ImageIO;

/** Paints an SVG with the machine's fonts, without a screen. */
final class PngImage {
    /** For screens with small pixels. */
    private static final int SCALE = 2;

    private PngImage() {}

    static byte[] of(String svg) throws WrongUse {
        System.setProperty("java.awt.headless", "true");
        try {
            return paint(readable(svg));
        } catch (LinkageError | AWTError | InternalError | IOException e) {
            throw new WrongUse(
                    "this Java cannot paint letters (%s): install fonts, on Debian the package"
                            + " fonts-liberation, and a Java with them; --format svg needs neither",
                    String.valueOf(e.getMessage()));
        }
    }

    /** The machine's fonts for what Liberation Sans has no letters for; boxes help nobody. */
    private static String readable(String svg) throws WrongUse {
        String letters = svg.replaceAll("(?s)<style>.*?</style>|<[^>]*>", "");
        if (new Font("Liberation Sans", Font.PLAIN, 1).canDisplayUpTo(letters) < 0) {
            return svg;
        }
        int missing = new Font(Font.SANS_SERIF, Font.PLAIN, 1).canDisplayUpTo(letters);
        if (missing < 0) {
            return svg.replace("\"Liberation Sans\", Arimo", "SansSerif");
        }
        throw new WrongUse(
                "this machine has no font with the letter '%s'; install one, or take --format svg",
                Character.toString(letters.codePointAt(missing)));
    }

    private static byte[] paint(String svg) throws IOException {
        byte[] text = svg.getBytes(StandardCharsets.UTF_8);
        SVGDocument document =
                new SVGLoader()
                        .load(new ByteArrayInputStream(text), null, LoaderContext.createDefault());
        FloatSize size = document.size();
        BufferedImage image =
                new BufferedImage(
                        Math.round(size.width * SCALE),
                        Math.round(size.height * SCALE),
                        BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        try {
            graphics.setRenderingHint(
                    RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            graphics.setRenderingHint(
                    RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
            graphics.scale(SCALE, SCALE);
            document.render(null, graphics);
        } finally {
            graphics.dispose();
        }
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        return png.toByteArray();
    }
}
