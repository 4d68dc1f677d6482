package arcomat.pipeline.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.pipeline.WrongUse;

import org.junit.jupiter.api.Test;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;

import javax.imageio.ImageIO;

/** What is painted is what the SVG says, at twice the size. */
class PngImageTest {
    private static String svg(String text) {
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40\" height=\"30\">"
                + "<style>.logic { fill: #e2ecfb; }</style>"
                + "<g class=\"logic\"><rect width=\"40\" height=\"30\"/></g>"
                + "<text x=\"5\" y=\"20\" font-size=\"13\">"
                + text
                + "</text></svg>";
    }

    private static BufferedImage painted(String text) throws Exception {
        return ImageIO.read(new ByteArrayInputStream(PngImage.of(svg(text))));
    }

    @Test
    void coloursAndLetters() throws Exception {
        BufferedImage image = painted("stop");
        assertThat(image.getWidth()).isEqualTo(80);
        assertThat(image.getHeight()).isEqualTo(60);
        assertThat(image.getRGB(2, 2) & 0xffffff).isEqualTo(0xe2ecfb);
        assertThat(darkest(image)).isLessThan(100);
        assertThat(darkest(painted(""))).isGreaterThan(200);
    }

    @Test
    void aLetterThatNoFontHasIsNamed() {
        assertThatThrownBy(() -> painted("\ue000"))
                .isInstanceOf(WrongUse.class)
                .hasMessageContaining("no font with the letter '\ue000'")
                .hasMessageContaining("--format svg");
    }

    private static int darkest(BufferedImage image) {
        int darkest = 255;
        for (int x = 0; x < image.getWidth(); x++) {
            for (int y = 0; y < image.getHeight(); y++) {
                darkest = Math.min(darkest, image.getRGB(x, y) >> 8 & 0xff);
            }
        }
        return darkest;
    }
}
