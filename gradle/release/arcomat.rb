# A formula for Homebrew: in a tap of one's own, `brew install NAME/TAP/arcomat`.
class Arcomat < Formula
  desc "@description@"
  homepage "@home@"
  url "@releases@/@zip@"
  sha256 "@sha256@"
  license "Apache-2.0"
  depends_on "openjdk@17"

  def install
    libexec.install Dir["*"]
    (bin/"arcomat").write_env_script libexec/"bin/arcomat", Language::Java.java_home_env("17")
    bash_completion.install libexec/"share/bash-completion/completions/arcomat"
    zsh_completion.install libexec/"share/zsh/arcomat.zsh" => "_arcomat"
    fish_completion.install libexec/"share/fish/vendor_completions.d/arcomat.fish"
    man1.install Dir[libexec/"share/man/man1/*"]
  end

  test do
    assert_match version.to_s, shell_output("#{bin}/arcomat --version")
  end
end
