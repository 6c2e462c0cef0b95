"""The independent judge: looks at rows of joint positions that anybody may have written, and says what is legal."""
