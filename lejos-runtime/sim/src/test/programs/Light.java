import lejos.nxt.ColorSensor;
import lejos.nxt.LightSensor;
import lejos.nxt.SensorPort;
import lejos.nxt.SoundSensor;
import lejos.util.Delay;

/** Percentages between calibrated ends are not limited to 0 and 100. */
public class Light {
    public static void main(String[] args) {
        LightSensor light = new LightSensor(SensorPort.S1);
        SoundSensor sound = new SoundSensor(SensorPort.S2);
        ColorSensor color = new ColorSensor(SensorPort.S3);
        for (int i = 0; i < 6; i++) {
            light.getLightValue();
            light.getNormalizedLightValue();
            sound.readValue();
            color.getColorID();
            if (i == 0) {
                light.setLow(300);
                light.setHigh(600);
            }
            Delay.msDelay(100);
        }
    }
}
